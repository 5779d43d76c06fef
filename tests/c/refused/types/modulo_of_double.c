/* Operands that % does not take. */
int main(void)
{
    double d = 5.5;

    return d % 2; // error: operand
}
