/* Calls every small integer as if it were a function, with odd arguments. */
// ends: bad function pointer
static int mine(int n) { return n; }
static volatile unsigned sum;

int main(void)
{
    unsigned start = (unsigned) mine + 1, i;

    for (i = 0; i < 100000; i++)
        sum += ((int (*)(void *, double, int, int, int)) (start + i))((void *) i, 1.5, -1, 0, i);
    return 0;
}
