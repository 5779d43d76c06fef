/* The same through a pointer. */
static int half(int n)
{
    if (n % 2 == 0)
        return n / 2;
}

int main(void)
{
    int (*f)(int) = half;
    int ok = f(4);

    return ok + f(5); // error: no value returned
}
