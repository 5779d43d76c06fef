/* Pointers are subtracted from pointers of their kind; nothing else is done with two of them. */
int main(void)
{
    int a[3], *p = a;
    char *c = (char *) a;
    double d = 1;

    p = p + p; // error: invalid operands to binary expression ('int *' and 'int *')
    p = p * 2; // error: invalid operands to binary expression ('int *' and 'int')
    p = p + d; // error: invalid operands to binary expression ('int *' and 'double')
    p = p - c; // error: invalid operands to binary expression ('int *' and 'char *')
    p = ~p; // error: invalid argument type 'int *' to unary expression
    p = -p; // error: invalid argument type 'int *' to unary expression
    p = p % 2; // error: invalid operands to binary expression ('int *' and 'int')
    p = p << 1; // error: invalid operands to binary expression ('int *' and 'int')
    return p == a;
}
