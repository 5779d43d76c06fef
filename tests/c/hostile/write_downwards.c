/* Writes over its own stack, downwards. */
// ends: out of bounds
int main(void)
{
    int here;
    int *p;

    for (p = &here;; p--)
        *p = -1;
}
