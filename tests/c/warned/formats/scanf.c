/* scanf formats that do not match their arguments. */
#include <stdio.h>

int main(void)
{
    int i = 0;
    float f = 0;
    double d = 0;
    char name[20] = "";

    if (scanf("%d", i) != 1)  // warning: '%d' specifies type 'int *' but the argument has type 'int'
//             ^
        return 1;
    sscanf("1", "%f", &d);  // warning: use '%lf'
    sscanf("1", "%lf", &f);  // warning: use '%f'
    sscanf("1", "%d %d", &i);  // warning: '%d' has no argument
    sscanf("1", "%hd", &i);  // warning: '%hd' specifies type 'short *' but the argument has type 'int *'
    sscanf("1 2", "%d %*d %lf %19s %[^,]%n %c", &i, &d, name, name, &i, &name);
    return 0;
}
