/* A type where a value is wanted. */
typedef int number;

int main(void)
{
    return number + 1; // error: 
}
