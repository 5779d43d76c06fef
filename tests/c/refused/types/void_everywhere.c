/* void is the type of nothing: it is not read, stored, added or declared. */
static void nothing(void) { }

int main(void)
{
    void *p = 0;
    int n;
    void v; // error: variable 'v' has incomplete type 'void'

    n = nothing() + 1; // error: invalid operands to binary expression ('void' and 'int')
    n = *p; // error: assigning to 'int' from incompatible type 'void'
    if (nothing()) // error: statement requires an expression of scalar type ('void' invalid)
        n = 1;
    n = (nothing(), 2);
    return !nothing(); // error: invalid argument type 'void' to unary expression
}
