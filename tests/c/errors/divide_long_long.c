/* long long division by zero. */
int main(void)
{
    long long n = 1ll << 40, z = 0;

    n /= z + 1;
    return n / z > 5; // error: division by zero
}
