/* Calls table entries from zero on. */
// ends: bad function pointer
int main(void)
{
    unsigned i;

    for (i = 0; i < 1000; i++)
        ((void (*)(int, int)) i)(1, 2);
    return 0;
}
