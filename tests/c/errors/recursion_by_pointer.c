/* Recursion without end through a function pointer. */
static int (*again)(double);

static int deeper(double x) // error: stack overflow
{
    return again(x * 0.5) ? 1 : 2;
}

int main(void)
{
    again = deeper;
    return again(1);
}
