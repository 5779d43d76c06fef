/* Writes over everything above its own data, the heap and the end of memory. */
// ends: out of bounds
static char here;

int main(void)
{
    char *p;

    for (p = &here;; p++)
        *p = 0x55;
}
