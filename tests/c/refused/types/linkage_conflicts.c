/* A name keeps its type and its linkage. */
extern int a;
static int a; // error: static declaration of 'a' follows non-static declaration
int b;
double b; // error: redefinition of 'b' with a different type: 'double' and 'int'
int f(int);
int f(double); // error: conflicting types for 'f' ('int (double)' vs 'int (int)')
static int g(void);
int g(int n) { return n; } // error: conflicting types for 'g' ('int (int)' vs 'int (void)')
typedef int number;
typedef long number; // error: redefinition of 'number' as a different kind of symbol, previously a type
int twice = 1;
int twice = 2; // error: redefinition of 'twice'

int main(void)
{
    int c;
    int c; // error: redefinition of 'c'
    return 0;
}
