/* A shift of a long long by 64. */
int main(void)
{
    volatile unsigned n = 64;
    long long one = 1;

    return one << n > 0; // error: shift out of range
}
