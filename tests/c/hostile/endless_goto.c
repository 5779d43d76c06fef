/* Irreducible flow without end. */
// ends: running
int main(void)
{
    volatile int n = 0;

    if (n)
        goto b;
a:
    n++;
    if (n & 1)
        goto b;
    n += 3;
b:
    n ^= 5;
    if (n & 2)
        goto b;
    goto a;
}
