/* One path through a function lacks a return. */
static int sign(int n)
{
    if (n > 0)
        return 1;
    if (n < 0)
        return -1;
}

int main(void)
{
    int s = sign(5);

    return s + sign(0); // error: no value returned
}
