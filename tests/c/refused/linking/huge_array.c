/* An array that no memory holds. */
static char space[0x7fffffff]; // error: 

int main(void)
{
    return space[0];
}
