/* Writes over its own stack, upwards: its callers' frames and resume points. */
// ends: failed
static void smash(int value)
{
    int here[4];
    volatile int *p;

    for (p = here; p < here + 400; p++)
        *p = value;
}

static int caller(int n)
{
    if (n)
        return caller(n - 1) + 1;
    smash(0x7fffffff);
    return 0;
}

int main(void)
{
    return caller(5);
}
