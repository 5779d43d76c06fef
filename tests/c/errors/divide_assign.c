/* A compound assignment that divides by zero. */
int main(void)
{
    unsigned char c = 100, z = 0;

    c /= z; // error: division by zero
    return c;
}
