/* Threads are not supported. */
#include <threads.h> // error: header 'threads.h' is not found

int main(void)
{
    return 0;
}
