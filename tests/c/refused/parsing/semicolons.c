/* Semicolons that are missing, told where they belong. */
int main(void)
{
    int a = 3  // error: expected ';' after '3'
//           ^
    a = a + 1  // error: expected ';' after '1'
//           ^
    return a }  // error: expected ';' after 'a'
//          ^
