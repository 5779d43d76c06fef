/* Functions that no header declares: for library functions the header is suggested. */
int main(void)
{
    double root = sqrt(2.0);  // warning: implicit declaration of function 'sqrt'
//                ^
    printf("%d\n", root > 2);  // warning: include <stdio.h>
    inet_addr("10.0.0.1");  // warning: include <arpa/inet.h>
    return root > 2;
}
