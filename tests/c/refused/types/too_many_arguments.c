/* A call with too many arguments for the prototype. */
#include <string.h>

int main(void)
{
    return strlen("abc", 3); // error: argument
}
