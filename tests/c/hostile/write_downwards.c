/* Writes over its own stack, downwards. */
// ends: null pointer
int main(void)
{
    int here;
    int *p;

    for (p = &here;; p--)
        *p = -1;
}
