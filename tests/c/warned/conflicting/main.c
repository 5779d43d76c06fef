/* Conflicting declarations in different files. */
#include <stdio.h>

extern char *name;  // warning: 'name' is 'char *' here, but 'char[5]' where it is defined
//           ^
extern int table[4];  // warning: 'table' is 'int[4]' here, but 'int[3]' where it is defined
double speed(int);  // warning: 'speed' is 'double (int)' here, but 'int (int)' where it is defined
extern long count;
extern int limit();
int shared;

int main(void)
{
    printf("%p %d %g %ld\n", (void *)&name, table[0], speed(1), count + limit(1) + shared);
    return 0;
}
