/* One element behind a local array, by a loop that goes one too far. */
int main(void)
{
    int a[10], i;

    for (i = 0; i <= 10; i++)
        a[i] = i; // error: out of bounds
    return 0;
}
