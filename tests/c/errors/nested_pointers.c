static int deep(int n, int (*up)(void))
{
    int sum(void)
    {
        return n + (up ? up() : 0);
    }
    return n ? deep(n - 1, sum) : sum(); // error: stack overflow
}

int main(void)
{
    return deep(100, 0) == 5050 ? deep(300, 0) : 1;
}
