/* Behind a parameter whose address was taken. */
static int second(int n)
{
    int *p = &n;

    return p[1]; // error: out of bounds
}

int main(void)
{
    return second(3);
}
