/* Structs support assignment, passing and member access only. */
struct s { int n; };

int main(void)
{
    struct s a = { 1 }, b = { 2 };
    int n = 3;

    if (a == b) // error: invalid operands to binary expression ('struct s' and 'struct s')
        n++;
    n = a + b; // error: invalid operands to binary expression ('struct s' and 'struct s')
    n = !a; // error: invalid argument type 'struct s' to unary expression
    n = (int) a; // error: operand of type 'struct s' where arithmetic or pointer type is required
    a = (struct s) n; // error: used type 'struct s' where arithmetic or pointer type is required
    n = a ? 1 : 2; // error: used type 'struct s' where arithmetic or pointer type is required
    while (b) // error: statement requires an expression of scalar type ('struct s' invalid)
        n--;
    return n;
}
