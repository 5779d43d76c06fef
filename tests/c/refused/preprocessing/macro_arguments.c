/* Too few arguments for a macro. */
#define ADD(a, b) ((a) + (b))

int main(void)
{
    return ADD(1); // error: argument
}
