/* A function of two arguments is called with one. */
static int add(int a, int b) { return a + b; }

int main(void)
{
    int (*f)(int) = (int (*)(int)) add;

    return f(2); // error: mismatched call
}
