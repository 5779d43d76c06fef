/* The element before a local array. */
int main(void)
{
    int a[4] = { 1, 2, 3, 4 }, i = 0;

    return a[i - 1]; // error: out of bounds
}
