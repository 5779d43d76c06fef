/* Reads upwards from its own data until memory ends. */
// ends: out of bounds
static char here;
static volatile unsigned sum;

int main(void)
{
    const char *p;

    for (p = &here;; p++)
        sum += *p;
}
