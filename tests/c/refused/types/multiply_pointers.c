/* Operands that * does not take. */
int main(void)
{
    int a = 1, *p = &a, *q = &a;

    return p * q; // error: operand
}
