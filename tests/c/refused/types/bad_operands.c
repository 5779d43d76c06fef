/* Operands that + does not take. */
struct point { int x, y; };

int main(void)
{
    struct point p = { 1, 2 };
    int n = p + 1; // error: operand

    return n;
}
