/* A shift by a negative count. */
int main(void)
{
    volatile int n = -1;
    unsigned u = 8;

    u >>= n; // error: shift out of range
    return u;
}
