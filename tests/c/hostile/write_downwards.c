/* Writes over its own stack, downwards. */
int main(void)
{
    int here;
    int *p;

    for (p = &here;; p--)
        *p = -1;
}
