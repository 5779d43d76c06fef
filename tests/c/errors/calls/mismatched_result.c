/* The result has a different type from the one that the pointer's type says. */
static double half(int n) { return n / 2.0; }

int main(void)
{
    int (*f)(int) = (int (*)(int)) half;

    return f(5); // error: mismatched call
}
