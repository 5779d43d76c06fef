/* Recursion that returns, 2 to the 60 times. */
// ends: running
static int f(int n)
{
    return n ? f(n - 1) + f(n - 1) : 1;
}

int main(void)
{
    return f(60);
}
