/* Calls without end, each of which returns. */
// ends: running
static int f(int n) { return n + 1; }
static int (*volatile p)(int) = f;

int main(void)
{
    int n = 0;

    for (;;)
        n = p(n);
}
