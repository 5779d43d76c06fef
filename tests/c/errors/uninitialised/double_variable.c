/* A sum without a start. */
int main(void)
{
    double sum;
    int i;

    for (i = 0; i < 3; i++)
        sum += i; // error: uninitialised read
    return sum > 0;
}
