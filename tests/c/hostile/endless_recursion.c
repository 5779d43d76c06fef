/* Recursion without end. */
// ends: stack overflow
static int f(volatile int n)
{
    return f(n + 1) + f(n + 2);
}

int main(void)
{
    return f(0);
}
