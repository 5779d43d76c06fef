/* Invalid uses of nested functions. */
#include <stdarg.h>
int search(int n)
{
    void look(int i)
    {
        if (i * i == n)
            goto found; // error: use of undeclared label 'found'
    }
    look(n);
    return 0;
found:
    return 1;
}
int sum(int n)
{
    int add(int count, ...) // error: the address of nested function 'add' cannot be taken
    {
        return count + n;
    }
    int (*pointer)(int, ...) = add;
    return pointer(1, 2) + add(1, 2);
}
int main(void)
{
    int twice(int n) { return 2 * n; }
    int twice(int n) { return 2 * n; } // error: redefinition of 'twice'
    return twice(search(2) + sum(1));
}
