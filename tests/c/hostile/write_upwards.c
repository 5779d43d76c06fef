/* Writes over everything above its own data, the heap and the end of memory. */
// ends: pointer outside memory
static char here;

int main(void)
{
    char *p;

    for (p = &here;; p++)
        *p = 0x55;
}
