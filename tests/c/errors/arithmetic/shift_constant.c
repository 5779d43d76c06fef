/* A constant shift count that is too large. */
int main(void)
{
    volatile unsigned u = 1;

    return u << 33; // error: shift out of range
}
