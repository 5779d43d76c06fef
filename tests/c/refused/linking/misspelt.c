/* A misspelt function of the library. */
#include <stdio.h>
int main(void)
{
    prinft("hello\n");  // error: did you mean 'printf'?
//  ^
    return 0;
}
