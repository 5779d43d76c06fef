/* The same with the first member, which wraps around the end of all addresses. */
static int first(int *p) { return *p; } // error: pointer outside memory

int main(void)
{
    return first((int *) -1);
}
