/* A function gives the address of its own variable. */
static int *count(void)
{
    int n = 3, *p = &n;

    return p;
}

int main(void)
{
    int *p = count();

    return *p; // error: use after return
}
