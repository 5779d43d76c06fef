/* An element that the loop before has left out. */
int main(void)
{
    int a[10], i, sum = 0;

    for (i = 0; i < 9; i++)
        a[i] = i;
    for (i = 0; i < 10; i++)
        sum += a[i]; // error: uninitialised read
    return sum;
}
