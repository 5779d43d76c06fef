/* A function is no place to store to. */
static int f(void) { return 1; }
static int g(void) { return 2; }

int main(void)
{
    f = g; // error: not assignable
    return f();
}
