/* Unsigned division by zero. */
int main(void)
{
    unsigned zero = 0;

    return 7u / zero; // error: division by zero
}
