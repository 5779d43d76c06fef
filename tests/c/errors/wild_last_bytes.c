/* An access of eight bytes at the very last address. */
int main(void)
{
    double *d = (double *) 0xFFFFFFFC;

    return *d > 0; // error: pointer outside memory
}
