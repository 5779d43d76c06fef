/* A compound remainder by zero, unsigned long long. */
int main(void)
{
    unsigned long long n = 100, z = 0;

    n %= z; // error: division by zero
    return n != 0;
}
