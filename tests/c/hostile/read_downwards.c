/* Reads downwards through its own stack into the null page. */
// ends: null pointer
static volatile unsigned sum;

int main(void)
{
    int here;
    const int *p;

    for (p = &here;; p--)
        sum += *p;
}
