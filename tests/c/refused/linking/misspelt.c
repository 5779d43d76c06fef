/* Misspelt functions of the library, and of the robot */
#include <stdio.h>
#include <Nclient.h>
int main(void)
{
    prinft("hello\n");  // error: did you mean 'printf'?
//  ^
    scout_vn(10, 20);  // error: did you mean 'scout_vm'?
    return 0;
}
