/* A shift by the width of the type. */
int main(void)
{
    volatile int n = 32;

    return 1 << n; // error: shift out of range
}
