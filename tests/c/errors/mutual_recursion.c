/* Two functions that call each other without end; either may be the one that finds no room. */
static int ping(int n);
static int pong(int n) { int space[100]; space[n % 100] = n; return ping(n + 1) + space[0]; }
static int ping(int n) { return pong(n) + 1; }

int main(void)
{
    return ping(0);
}
// error: stack overflow (anywhere)
