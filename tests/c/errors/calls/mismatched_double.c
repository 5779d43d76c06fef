/* A function that takes an int is called with a double. */
static int twice(int n) { return 2 * n; }

int main(void)
{
    int (*f)(double) = (int (*)(double)) twice;

    return f(2.5); // error: mismatched call
}
