/* Storage classes where they cannot be. */
auto int a; // error: illegal storage class on file-scoped variable 'a'
register int b; // error: illegal storage class on file-scoped variable 'b'
static extern int c; // error: multiple storage classes

int main(void)
{
    extern int d = 5; // error: 'd' has both 'extern' and an initializer
    return d;
}
