/* Functions that no header declares: the library's are known, and the header is named. */
int main(void)
{
    double root = sqrt(2.0);  // warning: implicit declaration of function 'sqrt'
//                ^
    printf("%d\n", root > 2);  // warning: include <stdio.h>
    return root > 2;
}
