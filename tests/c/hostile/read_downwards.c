/* Reads downwards through its own stack into the null page. */
// ends: out of bounds
static volatile unsigned sum;

int main(void)
{
    int here = 0;
    const int *p;

    for (p = &here;; p--)
        sum += *p;
}
