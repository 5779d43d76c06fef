/* What is returned must convert to the function's type. */
struct s { int n; };
static int number(void) { struct s s = { 1 }; return s; } // error: returning 'struct s' from a function with incompatible result type 'int'
static struct s structure(void) { return 1; } // error: returning 'int' from a function with incompatible result type 'struct s'
static int *pointer(double d) { return d; } // error: returning 'double' from a function with incompatible result type 'int *'

int main(void)
{
    return number() + structure().n + *pointer(1);
}
