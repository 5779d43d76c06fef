/* Reads downwards through its own stack into the null page. */
// ends: uninitialised read
static volatile unsigned sum;

int main(void)
{
    int here;
    const int *p;

    for (p = &here;; p--)
        sum += *p;
}
