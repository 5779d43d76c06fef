/* An address far below the stack. */
static int sum, *p;

int main(void)
{
    int here = 1;

    p = &here - 50000;
    sum = *p; // error: wild pointer
    return sum;
}
