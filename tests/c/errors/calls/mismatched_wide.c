/* A function of a long long is called with an int. */
static int low(long long n) { return n & 255; }

int main(void)
{
    int (*f)() = (int (*)()) low;

    return f(2); // error: mismatched call
}
